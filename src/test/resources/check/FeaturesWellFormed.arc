//// Twice.arc
component Twice(Boolean low) {
  feature low, high, high;
//        ~~~ error ARC0150: arguments could not tell the two 'low' apart; rename one
//                   ~~~~ error ARC0150: arguments could not tell the two 'high' apart; rename one
}

//// Conditions.arc
component Conditions(Boolean wide) {
  feature far;
  constraint (far || wide);
//            ~~~~~~~~~~~ error ARC0150: this condition is to be about features of the component and nothing else: 'far'
  constraint far implies true;

  port in Boolean go;

  varif (fat) {
//       ~~~ error ARC0150: this condition is to be about features of the component and nothing else: 'far'
    varif (!far <=> (if far then false else true) && far == far && far != !far) { }
    else varif (go) { }
//              ~~ error ARC0150: this condition is to be about features of the component and nothing else: 'far'
  }
}

//// Nothing.arc
component Nothing {
  varif (true) { }
//       ~~~~ error ARC0150: there is no feature to choose; declare one, 'feature f;'
  varif (some) { }
//       ~~~~ error ARC0150: this condition is to be about features of the component and nothing else: declare them, 'feature f;'
}

//// Inside.arc
component Inside {
  feature outer;

  varif (outer) {
    feature deep;
//  ~~~~~~~~~~~~~ error ARC0150: features and their constraints belong to the component that the file is about; write this there, beside its ports
  }

  component Inner {
    feature inner;
//  ~~~~~~~~~~~~~~ error ARC0150: features and their constraints belong to the component that the file is about; write this there, beside its ports
    varif (outer) { constraint outer; }
//                  ~~~~~~~~~~~~~~~~~ error ARC0150: features and their constraints belong to the component that the file is about; write this there, beside its ports
  }
}

//// Many.arc
component Many {
  feature a, b, c, d, e, f, g;
//                          ~ error ARC0150: 'Many' has more than 64 configurations, and each is looked at by itself; delete features, or say by constraints which go together
}

//// TooMany.arc
component TooMany {
  feature a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q;
//                                                        ~ error ARC0150: 'TooMany' has more than 64 configurations, and each is looked at by itself; delete features, or say by constraints which go together
  constraint a && b && c && d && e && f && g && h && i && j && k && l && m && n && o && p;
}

//// GoodFeatures.arc
component GoodFeatures {
  feature a, b, c, d, e, f, g;
  constraint g;
}

//// Start.arc
component Start {
  feature slow;

  timing instant;

  port in Integer a, out Integer b;

  init { }
//~~~~~~~~ error ARC0150: 'init' belongs to no 'compute' here; write it between the same braces as the 'compute' that it begins
  varif (slow) { compute { b = a; } } else { compute { b = 2; } }
}

//// Parameter.arc
component Parameter(Integer n) {
  constraint (n > 3);
//            ~~~~~ error ARC0150: this condition is to be about features of the component and nothing else: declare them, 'feature f;'

  component Inner {
    constraint (false);
//  ~~~~~~~~~~~~~~~~~~~ error ARC0150: features and their constraints belong to the component that the file is about; write this there, beside its ports
  }
}
