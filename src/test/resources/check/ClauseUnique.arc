//// Bad.arc
component Bad {
  timing instant;
  timing delayed;
//~~~~~~~~~~~~~~~ error ARC0130: this component has a clause 'timing' already; delete one
  autoinstantiate off;
  autoinstantiate on;
//~~~~~~~~~~~~~~~~~~~ error ARC0130: this component has a clause 'autoinstantiate' already; delete one
  autoconnect port;
  autoconnect port;
//~~~~~~~~~~~~~~~~~ error ARC0130: this component has a clause 'autoconnect' already; delete one
  port in Boolean i, out Boolean o;
}

//// Good.arc
component Good {
  timing instant;
  autoinstantiate off;
  autoconnect port;
  port in Boolean i, out Boolean o;
}
