//// p/Bad.arc
package p;
component Bad extends Middle {
//                    ~~~~~~ error ARC0113: component 'Bad' extends itself: Bad -> Middle -> Bad; let one of them extend another component or none
  port in Integer power;
}

//// p/Middle.arc
package p;
component Middle extends Bad {
  port in Integer speed;
}

//// p/Self.arc
package p;
component Self extends Self {
//                     ~~~~ error ARC0113: component 'Self' extends itself: Self -> Self; let one of them extend another component or none
  port in Integer speed;
}

//// p/Heir.arc
package p;
component Heir extends Middle {
  port out Integer turns;
}

//// p/Good.arc
package p;
component Good extends Base {
  port in Integer power;
}

//// p/Base.arc
package p;
component Base {
  port in Integer speed;
}
