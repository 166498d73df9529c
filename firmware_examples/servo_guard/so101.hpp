// An SO-101 whose servos stand in their middle at the joints' zeros.
constexpr servo::Servo kServos[] = {
    {ARM(variable_shoulder_pan), 1, 2048, 1, 2000}, {ARM(variable_shoulder_lift), 2, 2048, 1, 2000},
    {ARM(variable_elbow_flex), 3, 2048, 1, 2000},   {ARM(variable_wrist_flex), 4, 2048, 1, 3000},
    {ARM(variable_wrist_roll), 5, 2048, 1, 3000},   {ARM(variable_gripper), 6, 2048, 1, 3000},
};
