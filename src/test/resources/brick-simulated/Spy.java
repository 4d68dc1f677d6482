//// robot/Spy.java
package robot;

import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import java.net.Socket;

public class Spy extends Thread {
//           ~~~ error ARC0916: robot.Spy.socket uses java.net.Socket, which the simulated brick does not have: 'run-brick' and 'world' cannot run this program
    private Socket socket;

    public void look() throws IOException, ClassNotFoundException {
        new FileOutputStream(new File("log.txt")).write(1);
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0916: robot.Spy.look uses java.io.File, which the simulated brick does not have: 'run-brick' and 'world' cannot run this program
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0916: robot.Spy.look uses java.io.FileOutputStream, which the simulated brick does not have: 'run-brick' and 'world' cannot run this program
        Runtime.getRuntime().addShutdownHook(this);
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0916: robot.Spy.look uses Runtime.addShutdownHook(Thread), which the simulated brick does not have: 'run-brick' and 'world' cannot run this program
        Class.forName("arcomat.sim.Laboratory");
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0916: robot.Spy.look uses Class.forName(String), which the simulated brick does not have: 'run-brick' and 'world' cannot run this program
        new lejos.nxt.addon.EOPD(lejos.nxt.SensorPort.S1).readRawValue();
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0916: robot.Spy.look uses lejos.nxt.addon.EOPD, which the simulated brick does not have: 'run-brick' and 'world' cannot run this program
        setName(System.getProperty("user.home"));
//      ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ error ARC0916: robot.Spy.look uses System.getProperty(String), which the simulated brick does not have: 'run-brick' and 'world' cannot run this program
        new File("again");
    }
}

//// robot/GoodPart.java
package robot;

import lejos.nxt.LCD;
import lejos.nxt.Motor;

public class GoodPart extends Thread {
    private int[] numbers = {1, 2};

    public void run() {
        start();
        Motor.A.rotate(numbers.clone()[0]);
        LCD.drawString(getName() + numbers.length, 0, 0);
        System.exit(0);
    }
}
