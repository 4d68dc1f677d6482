package arcomat.generate.project;

/**
 * What the templates of a new project see.
 *
 * @param name as it was written
 * @param component what the robot is called, and what other names begin with
 * @param version of the tool, and so of its plugin
 * @param robot whether there is more than logic
 * @param campaign whether there are two robots, and many runs
 */
public record ProjectView(
        String name,
        String component,
        String packageName,
        String version,
        boolean robot,
        boolean campaign) {}
