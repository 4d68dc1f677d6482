package arcomat.pipeline.campaign.joint;

/**
 * Where a program keeps what a port of one of its parts shows.
 *
 * @param path of the part, and the port: {@code avoidCrash.cmd}
 * @param fields that lead from the component that the program runs to the part, with dots
 * @param message field of the part
 * @param flag field that says whether there is a message; empty where the message says it itself
 * @param silentAtZero whether it is none that is 0: codes of enums
 * @param before whether it shows in a slice what was sent in the one before, so that it is read
 *     before the step
 */
public record PortTap(
        String path,
        String fields,
        String message,
        String flag,
        boolean silentAtZero,
        boolean before) {}
