//// Bad.arc
component Bad {
  <<layer = "actuators">> component Motor motor {
    port in Integer power, out Integer turns;
  }
  component Control ctrl {
    port in Integer turns, in Integer distance, out Integer power, out Boolean ping;
  }
  <<layer = "sensors">> component Sonar sonar {
    port in Boolean ping, out Integer distance;
  }

  connect motor.turns -> ctrl.turns;
//                       ~~~~~~~~~~ error ARC0505: 'motor.turns' of the actuators cannot send to 'ctrl.turns' of the logic; messages flow from sensors to logic to actuators
  connect ctrl.power -> motor.power;
  connect ctrl.ping -> sonar.ping;
//                     ~~~~~~~~~~ error ARC0505: 'ctrl.ping' of the logic cannot send to 'sonar.ping' of the sensors; messages flow from sensors to logic to actuators
  connect sonar.distance -> ctrl.distance;
}

//// Good.arc
component Good {
  <<layer = "actuators">> component Motor motor {
    port in Integer power;
  }
  component Control ctrl {
    port in Integer distance, out Integer power;
  }
  <<layer = "sensors">> component Sonar sonar {
    port out Integer distance;
  }

  connect ctrl.power -> motor.power;
  connect sonar.distance -> ctrl.distance;
}
