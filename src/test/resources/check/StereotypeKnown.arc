//// Bad.arc
component Bad {
  port <<totl>> out Integer distance;
//       ~~~~ warning ARC0501: stereotype 'totl' means nothing here; did you mean 'total'?
  port <<bluetooth>> out Integer level;
//       ~~~~~~~~~ warning ARC0501: stereotype 'bluetooth' means nothing here; delete it, or suppress this finding if another tool needs it
}

//// Good.arc
<<platform, layer = "sensors">> component Good {
  port <<total>> out Integer distance, <<delay = "0">> out Integer level;
}
