//// shop/GoodKept.arc
package shop;
component GoodKept {
  port in Boolean i, out Boolean o;
}

//// shop/BadLost.arc
/** Lies beside the other. */
component BadLost {
//        ~~~~~~~ warning ARC0221: the file has no package, and files beside it have; write 'package shop;' above
  port in Boolean i, out Boolean o;
}

//// shop/Goods.cd
classdiagram Goods { enum Good { bread, milk; } }
//           ~~~~~ warning ARC0221

//// other/GoodAlone.arc
component GoodAlone {
  port in Boolean i, out Boolean o;
}
