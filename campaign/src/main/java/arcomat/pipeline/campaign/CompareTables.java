package arcomat.pipeline.campaign;

import arcomat.campaign.against.FinishedTable;
import arcomat.campaign.against.TableComparison;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.Failures;
import arcomat.report.campaign.TablesReport;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * Compares the table of a campaign with those that others have kept, one after the other.
 *
 * @param results the folder of the table, as the user wrote it
 * @param others folders of the others, likewise
 */
public record CompareTables(String results, List<String> others)
        implements Task<List<TablesReport>> {
    public CompareTables {
        others = List.copyOf(others);
    }

    /**
     * @throws WrongUse where there is no such table
     */
    @Override
    public List<TablesReport> run(Session session) throws WrongUse {
        List<TablesReport> all = new ArrayList<>();
        if (others.isEmpty()) {
            return all;
        }
        FinishedTable now = table(results, session);
        for (String each : others) {
            FinishedTable before = table(each, session);
            try {
                all.add(new TablesReport(before, now, TableComparison.of(before, now)));
            } catch (UncheckedIOException e) {
                throw Failures.cannot("read from", each, Objects.requireNonNull(e.getCause()));
            }
        }
        return all;
    }

    /**
     * A table that can be compared with.
     *
     * @param folder as the user wrote it
     */
    private static FinishedTable table(String folder, Session session) throws WrongUse {
        try {
            return StoredTable.read(folder, session.names());
        } catch (IOException e) {
            throw Failures.cannot("read from", folder, e);
        } catch (UncheckedIOException e) {
            throw Failures.cannot("read from", folder, Objects.requireNonNull(e.getCause()));
        }
    }

    /**
     * Looks at the others before any run is made: what is missing is told at once.
     *
     * @throws WrongUse where there is no such table
     */
    public void requireOthers(Session session) throws WrongUse {
        for (String each : others) {
            if (session.names().resolve(each).equals(session.names().resolve(results))) {
                throw new WrongUse(
                        "--against and --out name the same folder, '%s': its table is about to be"
                                + " written anew",
                        each);
            }
            table(each, session);
        }
    }
}
