package arcomat.agent.tool;

import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;

import java.time.Duration;
import java.util.List;

/**
 * A tool is called.
 *
 * @param session in which nothing outside of the model roots is read
 * @param roots the model roots, as the user wrote them
 * @param patience time that the call may take
 */
public record ToolCall(
        ToolArguments arguments, Session session, List<String> roots, Duration patience) {
    /** The files and folders that the call is about: all models, unless it names some. */
    List<String> paths() throws WrongUse {
        List<String> named = arguments.texts(ToolParameter.PATHS);
        return named.isEmpty() ? roots : named;
    }
}
