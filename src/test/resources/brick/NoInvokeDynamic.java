// java: 8
//// robot/Main.java
package robot;

public class Main {
    static void start() {
        Runnable task = () -> lejos.nxt();
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0902: robot.Main.start uses invokedynamic (a lambda or method reference), which cannot be linked for the brick; write plain Java 6
        Runnable other = Main::start;
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0902: robot.Main.start uses invokedynamic (a lambda or method reference), which cannot be linked for the brick; write plain Java 6
        Runnable good = new Runnable() {
            public void run() {}
        };
    }

    static class lejos {
        static void nxt() {}
    }
}
