component Network{port in Integer speedOfTheLeftMotor,in Integer speedOfTheRightMotor,out Integer distanceToTheObject;component Sensor<Integer>(1,"a") left[value->controller.leftInput,logger.firstInput],right[value->controller.rightInput];
component   Inner{}
connect speedOfTheLeftMotor->controller.speedOfTheLeftMotor,controller.backup.speedOfTheLeftMotor,logger.secondInput;
table{in a,b;out c;
|1|alt{fwd,stop}|=>|--|;// first
|*|--|=>|a+b*2|;
}
java inv limits:{ if (a)
      return; };
}
