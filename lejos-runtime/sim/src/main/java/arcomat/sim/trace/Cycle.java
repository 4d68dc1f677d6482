package arcomat.sim.trace;

import arcomat.sim.device.SensorName;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * One round of a program's main loop: what it did from one sleep to the next.
 *
 * @param start microseconds since the brick was switched on
 */
public record Cycle(long start, List<Event> events) {
    public Cycle {
        events = List.copyOf(events);
    }

    /** The sensors read, with their last values. */
    public Map<SensorName, Integer> read() {
        Map<SensorName, Integer> values = new EnumMap<>(SensorName.class);
        for (Event event : events) {
            if (event instanceof Event.SensorRead sensor) {
                values.put(sensor.socket(), sensor.value());
            }
        }
        return values;
    }

    /** What motors were told. */
    public List<Event.MotorOrdered> orders() {
        return events.stream()
                .filter(Event.MotorOrdered.class::isInstance)
                .map(Event.MotorOrdered.class::cast)
                .toList();
    }
}
