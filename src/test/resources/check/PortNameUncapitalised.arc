//// Bad.arc
component Bad {
  port in Integer Distance, speed, out Boolean Alert;
//                ~~~~~~~~ warning ARC0210: port 'Distance' should start with a small letter; rename it
//                                             ~~~~~ warning ARC0210
}

//// Good.arc
component Good {
  port in Integer distance, in Boolean, out Boolean alert;
}
