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
