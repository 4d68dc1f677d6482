package arcomat.report.campaign;

import arcomat.campaign.Row;
import arcomat.report.text.Printable;

import java.util.List;
import java.util.regex.Pattern;

/**
 * How runs of a campaign are made again, by a command that any shell takes.
 *
 * @param world the world's file, as a user would write it
 * @param limited whether programs met the limits of real bricks
 * @param libraries model roots of others that the programs were made with, as the user wrote them
 * @param guests where guests came from that the programs were made with, as the user wrote them
 */
public record RunAgain(String world, boolean limited, List<String> libraries, List<String> guests) {
    public RunAgain {
        guests = List.copyOf(guests);
        libraries = List.copyOf(libraries);
    }

    /** What a shell takes as it stands. */
    private static final Pattern PLAIN = Pattern.compile("[\\w./:=,+@%-]+");

    /** Where the page of a run is written if nobody minds. */
    private static final String RUN = "build/run";

    /** The command that makes a run again and shows it. */
    public String command(Row row) {
        return command(row, RUN);
    }

    /**
     * The same with the page somewhere.
     *
     * @param report the folder of its page
     */
    public String command(Row row, String report) {
        StringBuilder command = new StringBuilder("arcomat world ").append(word(world));
        command.append(" --seed ").append(row.trial().seed());
        row.trial()
                .seeds()
                .changes()
                .forEach(change -> command.append(" --then ").append(change.text()));
        row.trial()
                .values()
                .forEach(
                        (name, value) ->
                                command.append(" --set ").append(word(name + "=" + value)));
        libraries.forEach(each -> command.append(" --library ").append(word(each)));
        guests.forEach(each -> command.append(" --with ").append(word(each)));
        if (!limited) {
            command.append(" --no-limits");
        }
        return Printable.escape(command.append(" --report ").append(word(report)).toString());
    }

    /** In quotes where it needs them. */
    private static String word(String text) {
        return PLAIN.matcher(text).matches() ? text : "'" + text.replace("'", "'\\''") + "'";
    }
}
