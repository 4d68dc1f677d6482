package arcomat.pipeline;

import java.util.ArrayList;
import java.util.List;
import java.util.TimeZone;
import java.util.concurrent.Callable;

/** Computes the same thing as on machines in four time zones, on both sides of Greenwich. */
public final class FourZones {
    private static final List<String> NAMES =
            List.of("UTC", "Asia/Kolkata", "America/New_York", "Pacific/Kiritimati");

    private FourZones() {}

    /** What comes out in each of them. */
    public static <T> List<T> each(Callable<T> computation) throws Exception {
        TimeZone here = TimeZone.getDefault();
        List<T> results = new ArrayList<>();
        try {
            for (String name : NAMES) {
                TimeZone.setDefault(TimeZone.getTimeZone(name));
                results.add(computation.call());
            }
        } finally {
            TimeZone.setDefault(here);
        }
        return results;
    }
}
