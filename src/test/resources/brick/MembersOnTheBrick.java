// java: 8
//// robot/Bad.java
package robot;

import java.util.*;

public class Bad {
    private final Map<String, Integer> seen = new TreeMap<>();
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0904: the constructor of robot.Bad uses java.util.TreeMap, a class that leJOS NXJ 0.9.1 does not have; use java.util.HashMap

    static String text(int value) throws java.text.ParseException {
        String text = String.format("%d", value);
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0904: robot.Bad.text calls String.format(String, Object[]), which leJOS NXJ 0.9.1 does not have; join texts by +
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0904: robot.Bad.text uses java.text.ParseException, a class that leJOS NXJ 0.9.1 does not have; do without it
        if (text.contains("1")) {
//      ~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0904: robot.Bad.text calls String.contains(CharSequence), which leJOS NXJ 0.9.1 does not have; use indexOf(text) >= 0
            return text.split(",")[0];
//          ~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0904: robot.Bad.text calls String.split(String), which leJOS NXJ 0.9.1 does not have; use java.util.StringTokenizer
        }
        return text.replace("1", "2");
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0904: robot.Bad.text calls String.replace(CharSequence, CharSequence), which leJOS NXJ 0.9.1 does not have; it has replace(char, char)
    }

    static int size(List<String> names) {
        try {
            names.removeIf(null);
//          ~~~~~~~~~~~~~~~~~~~~~ error ARC0904: robot.Bad.size calls List.removeIf(Predicate), which leJOS NXJ 0.9.1 does not have; do without it
            java.util.concurrent.TimeUnit[] units = new java.util.concurrent.TimeUnit[2];
//          ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0904: robot.Bad.size uses java.util.concurrent.TimeUnit, a class that leJOS NXJ 0.9.1 does not have; do without it
            return names.size() + Arrays.asList(1, 2).size() + units.length;
//          ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0904: robot.Bad.size calls Arrays.asList(Object[]), which leJOS NXJ 0.9.1 does not have; do without it
        } catch (ArrayStoreException e) {
            return 0;
        } catch (java.util.ConcurrentModificationException | EnumConstantNotPresentException e) {
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0904: robot.Bad.size uses java.lang.EnumConstantNotPresentException, a class that leJOS NXJ 0.9.1 does not have; do without it
            return e.getStackTrace().length;
//          ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0904: robot.Bad.size calls RuntimeException.getStackTrace(), which leJOS NXJ 0.9.1 does not have; do without it
        }
    }

    static class Order extends AbstractMap<String, String> {
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0904: the constructor of robot.Bad.Order uses java.util.AbstractMap, a class that leJOS NXJ 0.9.1 does not have; do without it
//               ~~~~~ error ARC0904: robot.Bad.Order uses java.util.AbstractMap, a class that leJOS NXJ 0.9.1 does not have; do without it
        public Set<Map.Entry<String, String>> entrySet() {
            return keepAll();
        }

        private Set<Map.Entry<String, String>> keepAll() {
            return isEmpty() ? null : Collections.emptySet();
//          ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0904: robot.Bad.Order.keepAll uses java.util.Collections, a class that leJOS NXJ 0.9.1 does not have; do without it
        }
    }
}

//// robot/Good.java
package robot;

import java.util.*;

public class Good extends Thread {
    enum Mode { DRIVING, WAITING }

    private final int[] values = new int[3];

    @Override
    public void run() {
        List<Object> list = new ArrayList<>();
        for (Mode mode : Mode.values()) {
            list.add(values.clone().length + mode.name() + mode.ordinal() + mode.hashCode());
        }
        Runnable runnable = this;
        runnable.toString();
        StringBuilder text = new StringBuilder().append(1).append('c').append("s").append(2.0);
        synchronized (this) {
            notifyAll();
        }
        System.out.println(text);
        Comparable<String> comparable = "a";
        comparable.compareTo("b");
        setDaemon(true);
    }
}
