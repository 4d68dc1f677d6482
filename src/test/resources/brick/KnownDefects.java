//// robot/Order.java
package robot;

public class Order {
    enum Size { SMALL, LARGE }

    static Size read(String text) {
        if (text.compareTo("b") < 0) {
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0914: robot.Order.read calls String.compareTo, which on the brick takes texts of equal length for equal; compare their characters, or use equals
            return Size.valueOf(text);
//          ~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0914: robot.Order.read calls Size.valueOf, which always throws on the brick; compare the text with the name() of each constant
        }
        return Enum.valueOf(Size.class, text);
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0914: robot.Order.read calls Enum.valueOf, which always throws on the brick; compare the text with the name() of each constant
    }
}

//// robot/GoodOrder.java
package robot;

public class GoodOrder {
    static int compare(Integer a, Integer b) {
        return Integer.valueOf(a).compareTo(b) + String.valueOf(a).length();
    }
}

//// robot/Register.java
package robot;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Hashtable;
import java.util.List;
import java.util.Map;

public class Register {
    static class Words extends HashSet<String> {
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0914: the constructor of robot.Register.Words uses HashSet, which on the brick throws for a key with a negative hashCode; use java.util.Hashtable, or search a list
    }

    private final Map<String, String> given = new HashMap<String, String>();
//  ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0914: the constructor of robot.Register uses HashMap, which on the brick throws for a key with a negative hashCode; use java.util.Hashtable, or search a list
    private final Hashtable<String, String> fine = new Hashtable<String, String>();
    private final List<String> list = new ArrayList<String>();

    boolean knows(HashSet<Integer> known, HashMap<Integer, String> names, Words words) {
        fine.put("a", given.get("a"));
        if (known.contains(-1) && names.get(-1) != null) {
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0914: robot.Register.knows uses HashMap, which on the brick throws for a key with a negative hashCode; use java.util.Hashtable, or search a list
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0914: robot.Register.knows uses HashSet, which on the brick throws for a key with a negative hashCode; use java.util.Hashtable, or search a list
            return known.size() > 0;
        }
        return words.contains("a") || list.contains("a");
    }

    HashMap<Integer, String> made() {
        return new HashMap<Integer, String>();
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0914: robot.Register.made uses HashMap, which on the brick throws for a key with a negative hashCode; use java.util.Hashtable, or search a list
    }
}
