//// p/Bad.arc
package p;
component Bad {
  port in List<String> names, out Map<String, ArrayList<Integer>> places;
//        ~~~~ warning ARC0147: type 'List' is not in sight of this file; add 'import java.util.List;'
//                                ~~~ warning ARC0147: type 'Map' is not in sight of this file; add 'import java.util.Map;'
//                                            ~~~~~~~~~ warning ARC0147: type 'ArrayList' is not in sight of this file; add 'import java.util.ArrayList;'
}

//// p/Own.cd
package p;
classdiagram Own { type Stack; }

//// p/Good.arc
package p;
import java.util.List;
import java.util.concurrent.*;
component Good<Queue> {
  port in List<String> names, in java.util.Map<String, String> places, in Queue parameter, in Stack own;
  port in BlockingQueue<String> other;
}

//// p/GoodAll.arc
package p;
import java.util.*;
component GoodAll {
  port in List<String> names;
}
