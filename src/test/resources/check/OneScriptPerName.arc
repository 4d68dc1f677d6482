//// BadName.arc
component BadName {
  port in Integer spеed, out Integer αа;
//                ~~~~~ warning ARC0220: 'spеed' has letters of several scripts, such as a Latin and a Cyrillic a, which look alike; write the name in one
//                                   ~~ warning ARC0220
}

//// GoodName.arc
/** 'spеed' may be mixed in comments. */
component GoodName {
  port in Integer größe_2, out Integer скорость, out Integer ταχύ, in Integer café;
}
