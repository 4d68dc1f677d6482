//// Bad.arc
component Bad {
  port in Integer speed;

  component Drive drive {
    port in Integer speed;

    component Motor motor {
      port in Integer power;
    }

    connect speed -> motor.power;
  }

  connect speed -> drive.motor.power, drive.speed;
//                 ~~~~~~~~~~~~~~~~~ error ARC0102: 'drive.motor.power' reaches into 'drive'; connect a port of 'drive' and, inside it, that port with the part
}

//// Good.arc
component Good {
  port in Integer speed;

  component Drive drive {
    port in Integer speed;

    component Motor motor {
      port in Integer power;
    }

    connect speed -> motor.power;
  }

  connect speed -> drive.speed;
}
