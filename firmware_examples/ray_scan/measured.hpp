// The sensor's readings at the shelves. They are invented: the map's distances with 1.2 % of noise,
// and a carton that was put on a shelf after the map was made.
#pragma once

#include <stdint.h>

#include "sensor.hpp"

constexpr uint16_t kMeasuredAtTheShelves[kZones] = {
    // In millimetres, from the upper left zone.
    1583, 1600, 1603, 1633, 1670, 1754, 1532, 1973,  //
    1566, 1552, 1568, 1596, 1608, 1728, 1480, 1924,  //
    1356, 1317, 1304, 1298, 1310, 1318, 1362, 1864,  //
    1511, 1510, 1503, 1575, 1602, 1682, 1418, 1844,  //
    1499, 1501, 1243, 1548, 1582, 1639, 1420, 1888,  //
    1504, 1522, 1524, 1473, 1501, 1540, 1408, 1871,  //
    1545, 1532, 1570, 1591, 1612, 1727, 1483, 1935,  //
    1615, 1597, 1609, 1613, 1701, 1746, 1504, 1933,  //
};
