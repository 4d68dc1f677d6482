//// Bad.arc
component Bad {
  port in Integer speed;

  component Motor {
    port in Integer power, in Boolean brake, out Integer turns;
  }

  component Motor left, right;
//                ~~~~ warning ARC0109: input 'brake' of 'left' receives nothing; connect it
//                ~~~~ warning ARC0109: output 'turns' of 'left' is read by nobody; connect it
//                      ~~~~~ warning ARC0109: input 'brake' of 'right' receives nothing; connect it
//                      ~~~~~ warning ARC0109: output 'turns' of 'right' is read by nobody; connect it

  connect speed -> left.power, right.power;
}

//// Good.arc
component Good {
  port in Integer speed, out Integer turns;

  component Motor {
    port in Integer power, out Integer turns;
  }

  component Motor left;
  <<suppress = "ARC0109: nobody counts turns">> component Motor right;

  connect speed -> left.power, right.power;
  connect left.turns -> turns;
}
