//// p/Sonar.arc
package p;
<<platform, layer = "sensors">> component Sonar {
  port out Integer distance;
}

//// p/Unit.arc
package p;
component Unit {
  port out Integer distance;
  component Sonar sonar;
  connect sonar.distance -> distance;
}

//// p/BadControl.arc
package p;
<<layer = "logic">> component BadControl {
  port out Integer distance;
  component Unit unit;
//               ~~~~ error ARC0504: 'BadControl' is logic, but contains the platform component 'unit.sonar'; connect the device from outside
  connect unit.distance -> distance;
}

//// p/BadDevice.arc
package p;
<<platform>> component BadDevice {
//                     ~~~~~~~~~ error ARC0504: platform component 'BadDevice' cannot belong to the logic; add <<layer = "sensors">> or <<layer = "actuators">>
  port out Integer level;
}

//// p/BadDevice2.arc
package p;
<<layer = "logic", platform>> component BadDevice2 {
//                                      ~~~~~~~~~~ error ARC0504: platform component 'BadDevice2' cannot belong to the logic; add <<layer = "sensors">> or <<layer = "actuators">>
  port out Integer level;
}

//// p/GoodControl.arc
package p;
<<layer = "logic">> component GoodControl {
  port in Integer distance, out Boolean near;
}

//// p/GoodRobot.arc
package p;
component GoodRobot {
  port out Boolean near;
  component Sonar sonar;
  component GoodControl control;
  connect sonar.distance -> control.distance;
  connect control.near -> near;
}
