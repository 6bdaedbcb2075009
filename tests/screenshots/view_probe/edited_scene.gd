@tool
extends RefCounted
## The edited scene: a mesh of the user's, and a node that draws an entry.


static func save(path: String) -> void:
	var root := Node3D.new()
	root.name = "Root"
	var box := MeshInstance3D.new()
	box.name = "Box"
	box.mesh = BoxMesh.new()
	box.position = Vector3(-3, 0.5, 0)
	root.add_child(box)
	box.owner = root
	var scene := GAScene.new()
	scene.add_entry("B", "point(0, 0.5, 0)")
	scene.add_entry("t", "sphere(B, 0.3)")
	var node := GANode3D.new()
	node.name = "Node"
	node.scene = scene
	node.entry = &"B"
	node.transform = Transform3D(
		Basis(Vector3.UP, 1.0).scaled(Vector3.ONE * 1.5), Vector3(0.9, 0, 2.3)
	)
	root.add_child(node)
	node.owner = root
	var packed := PackedScene.new()
	packed.pack(root)
	ResourceSaver.save(packed, path)
	root.free()
