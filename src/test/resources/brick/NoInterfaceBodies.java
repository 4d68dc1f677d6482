// java: 8
//// robot/Sensor.java
package robot;

public interface Sensor {
    Object LIMIT = new Object();

    int read();

    default int twice() {
        return 2 * read();
//      ~~~~~~~~~~~~~~~~~~ error ARC0903: interface robot.Sensor has the default method twice, which fails on the brick; move the body to a class
    }

    static int none() {
        return -1;
//      ~~~~~~~~~~ error ARC0903: interface robot.Sensor has the static method none, which fails on the brick; move the body to a class
    }
}
