//// robot/BadGuardTest.mt
package robot;

testsuite BadGuardTest for Guard {
  int slices;
//~~~~~~~~~~~ warning ARC0708: nobody knows the value of this field before the tests are run, so it is not used; give it a literal that no Java block changes, or give the tested component its values as arguments, as in 'for Guard(3)'

  test stops {
    input { tooClose: <true>; }
  }
}

//// robot/GoodGuardTest.mt
package robot;

testsuite GoodGuardTest for Guard {
  test stops {
    input { tooClose: <true>; }
  }
}

//// robot/Guard.arc
package robot;

component Guard {
  port in Boolean tooClose, out Boolean drive;

  automaton {
    state driving;
    initial driving / {drive = true};
    driving {tooClose == true} / {drive = false};
  }
}

//// robot/ChangedTest.mt
package robot;

testsuite ChangedTest for Guard {
  boolean near = true;
//~~~~~~~~~~~~~~~~~~~~ warning ARC0708: nobody knows the value of this field before the tests are run, so it is not used; give it a literal that no Java block changes, or give the tested component its values as arguments, as in 'for Guard(3)'

  @Before {
// ~~~~~~ warning ARC0708: the Java block '@Before' is not run; say what should happen before with messages in the first slices
    near = false;
  }

  test stops {
    input { tooClose: <near>; }
//                     ~~~~ error ARC0329: 'near' is not a literal or a constant of an enum; declare it or correct the name
  }
}

//// robot/WrongTest.mt
package robot;

testsuite WrongTest for Guard {
  boolean near = 3;
//               ~ error ARC0317: field 'near' takes Boolean, but '3' is of type Integer
  int far = 7;

  test stops {
    input { tooClose: <far>; }
//                     ~~~ error ARC0703: port 'tooClose' takes Boolean, but 'far' is of type Integer
  }
}

//// robot/GoodFieldTest.mt
package robot;

testsuite GoodFieldTest for Guard {
  boolean near = true, far = false;
  int unused = -3;

  test stops {
    input { tooClose: <near, Tk, 2*(far, Tk)>; }
  }
}

//// robot/Things.cd
package robot;

classdiagram Things {
  type Parcel;
  class Cup { Integer volume; }
}

//// robot/Belt.arc
package robot;

component Belt {
  port in Parcel arrived, in Cup cup, out Parcel sent;
}

//// robot/GoodMessageTest.mt
package robot;

testsuite GoodMessageTest for Belt {
  Parcel first = Parcel("first");
  Cup small = Cup(5);

  test passes {
    input { arrived: <first, Tk, Parcel("second")>; cup: <small>; }
  }
}

//// robot/OfJavaTest.mt
package robot;

testsuite OfJavaTest for Belt {
  Parcel one, two;
//~~~~~~~~~~~~~~~~ warning ARC0708: whatever Java gives this field, it stands for a message of its own, as if 'Parcel("one")' were written; fields that should be equal are one field
  Parcel three = new Parcel(3);
//~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0708: whatever Java gives this field, it stands for a message of its own, as if 'Parcel("three")' were written; fields that should be equal are one field
  Parcel four = Parcel("x");
//~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0708: whatever Java gives this field, it stands for a message of its own, as if 'Parcel("four")' were written; fields that should be equal are one field
  byte[] bytes;
//~~~~~~~~~~~~~ warning ARC0708: nobody knows the value of this field before the tests are run, so it is not used; give it a literal that no Java block changes, or give the tested component its values as arguments, as in 'for Belt(3)'
  Cup cup;
//~~~~~~~~ warning ARC0708: nobody knows the value of this field before the tests are run, so it is not used; give it a literal that no Java block changes, or give the tested component its values as arguments, as in 'for Belt(3)'

  @Before {
// ~~~~~~ warning ARC0708: the Java block '@Before' is not run; say what should happen before with messages in the first slices
    one = new Parcel(1);
    two = new Parcel(2);
    four = two;
  }

  test passes {
    input { arrived: <one, Tk, two, Tk, three, Tk, four>; cup: <cup>; }
//                                                              ~~~ error ARC0329: 'cup' is not a port, a variable or a parameter; declare it or correct the name
    expect { sent: <Tk, one>; }
  }
}
