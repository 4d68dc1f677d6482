package arcomat.pipeline.campaign;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.file.Failures;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** Takes rows that parts of a campaign have made from where these keep them, and makes the rest. */
public final class StoredRows implements Engine {
    private final List<PartRows> parts;
    private final Engine beside;
    private final List<Row> found = new ArrayList<>();
    private int missing;

    private StoredRows(List<PartRows> parts, Engine beside) {
        this.parts = parts;
        this.beside = beside;
    }

    /**
     * Who makes the runs of a campaign of which parts have been made.
     *
     * @param folders of the parts, as the user wrote them
     * @param others who makes what no part has
     * @throws WrongUse where a folder has no part of this campaign
     */
    public static Function<Freight, Engine> engines(
            List<String> folders,
            PrepareCampaign.Ready ready,
            Function<Freight, Engine> others,
            Session session)
            throws WrongUse {
        List<Path> files = new ArrayList<>();
        for (String folder : folders) {
            try {
                files.add(ResultFolder.part(folder, ready.freight().hash(), session.names()));
            } catch (IOException e) {
                throw Failures.cannot("read from", folder, e);
            }
        }
        return freight -> open(files, ready, others.apply(freight));
    }

    private static Engine open(List<Path> files, PrepareCampaign.Ready ready, Engine beside) {
        List<PartRows> parts = new ArrayList<>();
        try {
            for (Path file : files) {
                parts.add(PartRows.of(file, ready.campaign()));
            }
            return new StoredRows(parts, beside);
        } catch (IOException | IllegalArgumentException e) {
            beside.close();
            throw new EngineFailure("the rows of a part cannot be read: " + e.getMessage());
        }
    }

    @Override
    public int capacity() {
        return beside.capacity();
    }

    @Override
    public void submit(List<Trial> batch) {
        List<Trial> rest = new ArrayList<>();
        for (Trial trial : batch) {
            stored(trial).ifPresentOrElse(found::add, () -> rest.add(trial));
        }
        missing += rest.size();
        if (!rest.isEmpty()) {
            beside.submit(rest);
        }
    }

    /** Every part is asked for each trial, so that all of them go on. */
    private Optional<Row> stored(Trial trial) {
        Optional<Row> row = Optional.empty();
        try {
            for (PartRows part : parts) {
                Optional<Row> here = part.row(trial);
                row = row.isPresent() ? row : here;
            }
        } catch (IOException | IllegalArgumentException e) {
            throw new EngineFailure("the rows of a part cannot be read: " + e.getMessage());
        }
        return row;
    }

    @Override
    public List<Row> collect(Duration patience) {
        List<Row> rows = new ArrayList<>(found);
        found.clear();
        if (missing > 0) {
            List<Row> made = beside.collect(rows.isEmpty() ? patience : Duration.ZERO);
            missing -= made.size();
            rows.addAll(made);
        }
        return rows;
    }

    @Override
    public String crew() {
        return beside.crew();
    }

    @Override
    public void close() {
        beside.close();
        for (PartRows part : parts) {
            try {
                part.close();
            } catch (IOException e) {
                // What was read was read.
            }
        }
    }
}
