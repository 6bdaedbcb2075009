"""Situations of real games (situations/*.gd), each measured on processes over ENet on this machine."""

import situation_life_cases
import situation_scale_cases
import situation_setup_cases
import situation_time_cases

CASES = (
    *situation_time_cases.CASES,
    *situation_life_cases.CASES,
    *situation_scale_cases.CASES,
    *situation_setup_cases.CASES,
)
