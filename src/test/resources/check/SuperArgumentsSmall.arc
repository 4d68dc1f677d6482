//// Top.arc
component Top(Integer a) {
  port in Integer x;
}
//// Higher.arc
component Higher(Integer b) extends Top(b + b + b + b + b + b + b + b + b + b) { }
//// High.arc
component High(Integer c) extends Higher(c + c + c + c + c + c + c + c + c + c) { }
//// BadLow.arc
component BadLow(Integer d) extends High(d + d + d + d + d + d + d + d + d + d) { }
//                                  ~~~~ error ARC0135: what 'BadLow' gives to 'High' grows on the way up to more than 1000 names and operators; give less, or write a parameter less often
//// GoodLow.arc
component GoodLow(Integer d) extends High(d) { }
//// GoodLonger.arc
component GoodLonger(Integer d = 3) extends GoodLow(d + 1) { }
