//// p/Kinds.cd
package p;
classdiagram Kinds {
  enum Colour { red, green; }
  class Lamp extends Light { Colour colour; }
  class Light { Integer power; }
}

//// p/Painter.arc
package p;
import p.Kinds.*;
component Painter {
  port in Colour wanted, out Colour painted;
  automaton {
    state idle;
    initial idle / {painted = red};
    idle -> idle {wanted == green} / {painted = green};
  }
}

//// q/House.arc
package q;
import p.Painter;
import p.Kinds.Colour;
component House {
  port in Colour wish, out Colour wall;
  component Painter painter;
  connect wish -> painter.wanted;
  connect painter.painted -> wall;
}

//// q/HouseTest.mt
package q;
testsuite HouseTest for q.House {
  test paints {
    input { wish: <green, Tk>; }
    expect { wall: <red, Tk, green, Tk>; }
  }
}
