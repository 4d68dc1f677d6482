package arcomat.generate.view;

/**
 * A component whose behaviour comes from the target.
 *
 * @param senses whether it has outputs
 * @param acts whether it has inputs
 */
public record PlatformView(HeadView head, boolean senses, boolean acts) {}
