extends RefCounted
## Performs random actions: when a test calls it, when a node that it has made is moved
## or shown, and when an object that it watches emits a signal. So actions run while the code that
## caused the callback is on the stack.

const NotifyingNode := preload("res://tests/framework/notifying_node.gd")
## Actions within the callbacks of actions.
const MAX_DEPTH := 4
## One of so many callbacks performs an action.
const SPARSENESS := 2

var random := RandomNumberGenerator.new()
var actions: Array[Callable] = []
## Number of actions, and of those within callbacks.
var count := 0
var nested := 0

var _depth := 0
## Nodes whose notifications are on the stack: the engine does not support that they are freed.
var _busy: Array[Node] = []
## Nodes that may be leaving the tree: the engine does not support that others are freed then.
var _leaving := 0


## Performs one action.
func act() -> void:
	if _depth >= MAX_DEPTH:
		return
	_depth += 1
	count += 1
	nested += 1 if _depth > 1 or not _busy.is_empty() else 0
	var action: Callable = pick(actions)
	action.call()
	_depth -= 1


## Ends it: callbacks perform no actions any more.
func stop() -> void:
	_depth = MAX_DEPTH


## A random element, or null if there is none.
func pick(from: Array) -> Variant:
	return null if from.is_empty() else from[random.randi_range(0, from.size() - 1)]


## A new node whose callbacks perform actions.
func make_node() -> Node3D:
	var node := NotifyingNode.new(_moved)
	node.visibility_changed.connect(_shown.bind(node))
	node.tree_exiting.connect(func() -> void: _leaving += 1)
	node.tree_exited.connect(func() -> void: _leaving -= 1)
	return node


## Signals of the object perform actions.
func watch(object: Object, signals: Array[StringName]) -> void:
	for signal_name in signals:
		for information in object.get_signal_list():
			if information["name"] == signal_name:
				var arguments: Array = information["args"]
				var unused := arguments.size()
				object.connect(signal_name, _call_back.unbind(unused) if unused else _call_back)


## Moves a node to another parent, if the engine supports that now.
func reparent(node: Node, parent: Node) -> void:
	if _leaving == 0:
		node.reparent(parent)


## Frees a node, at the end of the frame if the engine does not support it now.
func free_node(node: Node) -> void:
	var is_busy := _busy.any(
		func(other: Variant) -> bool:
			return (
				is_instance_valid(other) and (node == other or node.is_ancestor_of(other as Node))
			)
	)
	if is_busy or _leaving > 0:
		node.queue_free()
	else:
		node.free()


func transform() -> Transform3D:
	var axis := Vector3(random.randfn(), random.randfn(), 1.0).normalized()
	return Transform3D(Basis(axis, random.randfn()), axis * random.randf_range(0.0, 9.0))


func _moved(node: Node) -> void:
	_busy.append(node)
	_call_back()
	_busy.pop_back()


## A synchronizer that leaves the tree shows what it has hidden.
func _shown(node: Node) -> void:
	_leaving += 1
	_moved(node)
	_leaving -= 1


func _call_back() -> void:
	if random.randi_range(1, SPARSENESS) == 1:
		act()
