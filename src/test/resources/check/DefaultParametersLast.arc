//// BadTimer.arc
component BadTimer[Integer slices = 2, Boolean once, Integer pause = 1, Boolean loud] {
//                                             ~~~~ error ARC0119: parameter 'once' has no default value but 'slices' before it has; move it to the front or give it one
//                                                                              ~~~~ error ARC0119
  port in Boolean start, out Boolean alert;
}

//// GoodTimer.arc
component GoodTimer[Boolean once, Integer slices = 2, Integer pause = 1] {
  port in Boolean start, out Boolean alert;
}
