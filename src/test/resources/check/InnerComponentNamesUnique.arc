//// Bad.arc
component Bad {
  port in Integer power;

  component Motor left {
    port in Integer power;
  }
  component Motor right {
//          ~~~~~ error ARC0215: component 'Bad' declares an inner component 'Motor' already; rename one, or use it for both parts
    port in Integer power;
  }

  connect power -> left.power, right.power;
}

//// Good.arc
component Good {
  port in Integer power;

  component Motor left {
    port in Integer power;
  }
  component Motor right;

  connect power -> left.power, right.power;
}
