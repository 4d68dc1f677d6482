//// Bad.arc
component Bad {
  port in Boolean x[3], in Boolean one, out Boolean y[2], out Boolean z;
  component Part part[2];
  connect x -> part.x;
//             ~~~~~~ error ARC0145: 'x' has 3 elements, but 'part.x' has 4 elements; connect as many, or name elements
  connect part.y -> y;
  connect part.y -> z;
//                  ~ error ARC0145: 'part.y' has 2 elements, but 'z' is one port; connect as many, or name elements
  connect x -> nowhere.x;
//             ~~~~~~~ error ARC0103: component 'Bad' has no part 'nowhere'; declare it, or name another part
  connect one -> part[2].x[0];
//               ~~~~~~~ error ARC0103: component 'Bad' has no part 'part[2]'; the array has part[0] to part[1]
}

//// Unknown.arc
component Unknown {
  port in Boolean x[3];
  connect x -> nobody.y;
//             ~~~~~~ error ARC0103: component 'Unknown' has no part 'nobody'; declare it, or name another part
  connect x -> y;
//             ~ error ARC0103: component 'Unknown' has no port 'y'; declare it, or connect another port
}

//// Part.arc
component Part {
  port in Boolean x[2], out Boolean y;
}

//// Good.arc
component Good {
  port in Boolean x[4], in Boolean one, out Boolean y[2], out Boolean z;
  component Part part[2], other[1] [y -> z];
  connect x -> part.x;
  connect one -> other.x;
  connect part.y -> y;
}

//// GoodElements.arc
component GoodElements {
  port in Boolean x[2], out Boolean y[2];
  component Part part[2];
  connect x[0] -> part[0].x, part[1].x[1];
  connect x[1] -> part[1].x[0];
  connect part[0].y -> y[1];
  connect part[1].y -> y[0];
}
