package arcomat.generate.view;

/**
 * A component whose behaviour comes from the target.
 *
 * @param senses whether it has outputs
 * @param acts whether it has inputs
 * @param general class written by hand that serves every instantiation of a generic component, to
 *     be extended; else empty
 */
public record PlatformView(HeadView head, boolean senses, boolean acts, String general) {
    /** The same, with a class to extend. */
    public PlatformView extending(String written) {
        return new PlatformView(head, senses, acts, written);
    }
}
