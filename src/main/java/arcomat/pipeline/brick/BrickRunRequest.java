package arcomat.pipeline.brick;

import arcomat.sim.Laboratory;
import arcomat.sim.device.Limits;
import arcomat.sim.device.SensorName;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * A program that is to run on a simulated brick.
 *
 * @param jar path of its jar
 * @param script path of a script that says what happens to the brick
 * @param devices what is plugged into sockets: kinds of devices, or paths of Java files
 * @param seconds of virtual time at most; empty for as long as the script says
 * @param patience of the PC's time at most
 * @param limits those of the brick that the program meets
 */
public record BrickRunRequest(
        String jar,
        Optional<String> script,
        Map<SensorName, String> devices,
        OptionalInt seconds,
        Duration patience,
        Limits limits) {
    public BrickRunRequest {
        devices = Map.copyOf(devices);
    }

    /** A request without devices, with the usual patience, and all limits. */
    public BrickRunRequest(String jar, Optional<String> script, OptionalInt seconds) {
        this(jar, script, Map.of(), seconds, Laboratory.PATIENCE, Limits.OF_THE_BRICK);
    }
}
