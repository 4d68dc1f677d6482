package arcomat.cli;

import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;

import java.util.regex.Pattern;

/**
 * Refuses paths without a letter. Java takes such a path for the folder that it was started in, but
 * whoever writes one has most often a variable in a script that has no value.
 */
final class EmptyPaths {
    /** The labels by which the help of commands marks paths. */
    private static final Pattern PATHS =
            Pattern.compile("(PATH|ROOT|DIR|FOLDER|GUEST|FILE|ROBOT|RECORDING)\\b.*");

    private EmptyPaths() {}

    /** Does the command, if nothing of it is an empty path. */
    static int execute(ParseResult parsed) {
        refuse(parsed);
        return new CommandLine.RunLast().execute(parsed);
    }

    private static void refuse(ParseResult parsed) {
        for (ArgSpec each : parsed.matchedArgs()) {
            if (PATHS.matcher(each.paramLabel()).matches()
                    && each.originalStringValues().contains("")) {
                throw new ParameterException(
                        parsed.commandSpec().commandLine(),
                        name(each)
                                + " is empty: name a file or a folder; '.' is the folder that"
                                + " arcomat is started in");
            }
        }
        if (parsed.hasSubcommand()) {
            refuse(parsed.subcommand());
        }
    }

    private static String name(ArgSpec argument) {
        return argument instanceof OptionSpec option ? option.longestName() : argument.paramLabel();
    }
}
