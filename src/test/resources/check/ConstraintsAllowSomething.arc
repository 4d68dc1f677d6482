//// Three.arc
component Three {
  feature a, b, c;
  constraint a;
  constraint b || c;
  constraint (a implies !b);
  constraint (b <=> a);
//            ~~~~~~~ error ARC0151: no choice of features makes this constraint and those before it true; no instance of 'Three' can be; correct one of them
}

//// One.arc
component One {
  feature a;
  constraint (a && !a);
//            ~~~~~~~ error ARC0151: no choice of features makes this constraint true; no instance of 'One' can be; correct it

}

//// GoodConstraints.arc
component GoodConstraints {
  feature a, b;
  constraint a <=> !b;
}

//// Never.arc
component Never {
  constraint (true && !true);
//            ~~~~~~~~~~~~~ error ARC0151: this constraint is false; no instance of 'Never' can be; correct it
}

//// Always.arc
component Always {
  constraint (!false);
}
