//// p/Robot.arc
package p;
import nxt.Brick.SensorPort;
import nxt.TouchSensor;
component Robot {
  port out Boolean hit;
  component TouchSensor(SensorPort.S1) touch;
  connect touch.pressed -> hit;
}

//// p/Twin.arc
package p;
component Twin {
  port out Boolean hit;
  component Robot robot;
  connect robot.hit -> hit;
}
