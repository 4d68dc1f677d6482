//// Bad.arc
component Bad {
  port <<suppress = "ARC0210: a name of 2012">> in Integer distance;
//       ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0507: there is no finding ARC0210 here to suppress; delete the suppression
}

//// Good.arc
<<suppress = "ARC0210: names of 2012">> component Good {
  port <<suppress = "ARC0210: the oldest of them">> in Integer Distance;
  port <<suppress = "ARC1002: what analyses find is not known here">> in Integer speed;
}

//// GoodMeant.arc
<<suppress = "ARC0507: the next version needs it again">> component GoodMeant {
  port <<suppress = "ARC0210: a name of 2012">> in Integer distance;
}
