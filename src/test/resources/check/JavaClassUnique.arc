//// p/Types.cd
package p;
classdiagram Types {
  enum Signal { alert; }
}

//// other/p/Types.cd
package p;
classdiagram Types {
  enum Signal { halt; }
//     ~~~~~~ error ARC0214: 'p.Types.Signal' is defined twice; rename one
}

//// p/BadFirst.arc
package p;
import p.Types.Signal;
component BadFirst {
  port in Signal i;
}

//// other/p/BadFirst.arc
package p;
component BadFirst {
//        ~~~~~~~~ error ARC0214: 'p.BadFirst' is defined twice; rename one
  port in Boolean i;
}

//// p/FirstTest.mt
package p;
testsuite FirstTest for BadFirst {
  test isNotAskedWhichOne {
    input { i: <true>; }
    expect { }
  }
}

//// p/Motor.arc
package p;
component Motor {
  port in Integer speed;

  component Left left {
    port in Integer speed;
  }

  connect speed -> left.speed;
}

//// p/MotorLeft.arc
package p;
component MotorLeft {
//        ~~~~~~~~~ error ARC0214: 'p.MotorLeft' and 'p.Motor.Left' give one Java class; rename one
  port in Integer speed;
}

//// q/Good.arc
package q;
component Good {
  port in Boolean i;
}

//// q/Signals.cd
package q;
classdiagram Signals {
  enum Signal { alert; }
}
