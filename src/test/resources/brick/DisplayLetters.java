//// robot/Greeting.java
package robot;

public class Greeting {
    static String of(boolean isMorning) {
        return isMorning ? "Grüße" : "good evening";
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ warning ARC0915: robot.Greeting.of has a text with 'ü', which the brick's display cannot show; use the letters of ASCII
    }
}

//// robot/GoodGreeting.java
package robot;

public class GoodGreeting {
    static final String RULES = "~ {a line}\n";
}
