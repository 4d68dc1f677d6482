//// Bad.arc
component Bad {
  port <<suppress = "ARC0210">> in Integer Distance;
//       ~~~~~~~~~~~~~~~~~~~~ error ARC0506: 'suppress' needs a code and a reason, as in <<suppress = "ARC0108: reason">>
//                                         ~~~~~~~~ warning ARC0210
  port <<suppress = "ARC9210: a name of 2012">> out Integer Speed;
//                  ~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0506: no check has the code 'ARC9210'; 'suppress' takes the code of a finding
//                                                          ~~~~~ warning ARC0210
}

//// Good.arc
component Good {
  port <<suppress = "ARC0210: a name of 2012">> in Integer Distance;
}
