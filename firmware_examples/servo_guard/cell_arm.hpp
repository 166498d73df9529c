// The arm of robot_guard. A servo's variable and id, its count at the joint's zero, 1 or -1 (counts
// grow as the joint's value falls), and the counts that it moves in a second at most.
constexpr servo::Servo kServos[] = {
    {ARM(variable_turn), 1, 2048, 1, 2000},
    {ARM(variable_shoulder), 2, 1800, -1, 2000},
    {ARM(variable_elbow), 3, 2048, 1, 3000},
    {ARM(variable_roll), 4, 2048, -1, 4000},
};
