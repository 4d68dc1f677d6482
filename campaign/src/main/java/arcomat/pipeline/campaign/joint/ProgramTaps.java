package arcomat.pipeline.campaign.joint;

import arcomat.sim.load.Probe;

import java.util.List;

/**
 * What is looked at in a program.
 *
 * @param type full name of the class of the component that it runs
 */
public record ProgramTaps(String type, List<PortTap> taps) {
    /** A slice of generated code. */
    private static final String STEP = "step";

    public ProgramTaps {
        taps = List.copyOf(taps);
    }

    /** Where a slice of it begins and ends. */
    Probe probe() {
        return new Probe(type, STEP);
    }

    /** Whether a call is that of a slice. */
    boolean isSlice(Object object, String method) {
        return method.equals(STEP) && object.getClass().getName().equals(type);
    }

    /** The place of a path, or -1. */
    int index(String path) {
        return taps.stream().map(PortTap::path).toList().indexOf(path);
    }
}
