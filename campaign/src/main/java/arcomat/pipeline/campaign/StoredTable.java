package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignParser;
import arcomat.campaign.Judge;
import arcomat.campaign.Row;
import arcomat.campaign.TableText;
import arcomat.campaign.against.FinishedTable;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.source.Sha256;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.Optional;
import java.util.stream.Stream;

/** Reads a table that a campaign has kept, with what it asks. */
final class StoredTable {
    private final String folder;
    private final Path table;
    private final Campaign campaign;
    private final TableText text;

    private StoredTable(String folder, Path table, Campaign campaign) {
        this.folder = folder;
        this.table = table;
        this.campaign = campaign;
        this.text = new TableText(campaign);
    }

    /**
     * @param folder as the user wrote it
     * @throws WrongUse where there is no such table
     */
    static FinishedTable read(String folder, PathNames names) throws IOException, WrongUse {
        Path table = names.resolve(folder).resolve(ResultFolder.TABLE);
        Path asked = names.resolve(folder).resolve(AskedCampaign.FILE);
        if (!Files.exists(table) || !Files.exists(asked)) {
            throw new WrongUse(
                    "'%s' has no finished table: %s and %s, which campaign --out writes",
                    folder, ResultFolder.TABLE, AskedCampaign.FILE);
        }
        Optional<Campaign> campaign =
                AskedCampaign.of(Files.readString(asked))
                        .map(each -> new SourceFile(AskedCampaign.FILE, each.text()))
                        .flatMap(each -> CampaignParser.parse(each).campaign());
        if (campaign.isEmpty()) {
            throw new WrongUse(
                    "%s in '%s' is no campaign that this version of the tool can read",
                    AskedCampaign.FILE, folder);
        }
        return new StoredTable(folder, table, campaign.get()).finished();
    }

    private FinishedTable finished() throws IOException, WrongUse {
        Judge judge = new Judge(campaign);
        try {
            String hash = digest(judge);
            try (Stream<Row> rows = rows();
                    ColumnFiles columns = ColumnFiles.of(campaign, rows)) {
                return new FinishedTable(
                        folder, campaign, judge.result(columns::measured), hash, this::rows);
            }
        } catch (IllegalArgumentException e) {
            throw new WrongUse(
                    "%s in '%s' is not the table of the campaign beside it: %s",
                    ResultFolder.TABLE, folder, String.valueOf(e.getMessage()));
        }
    }

    /** Reads all rows once. */
    private String digest(Judge judge) throws IOException {
        MessageDigest digest = Sha256.begin();
        boolean isHead = true;
        try (Stream<String> lines = Files.lines(table)) {
            for (String line : (Iterable<String>) lines::iterator) {
                digest.update((line + "\n").getBytes(StandardCharsets.UTF_8));
                if (isHead && !line.equals(text.header())) {
                    throw new IllegalArgumentException("it has other columns");
                } else if (!isHead) {
                    judge.see(text.row(line));
                }
                isHead = false;
            }
        }
        return HexFormat.of().formatHex(digest.digest(), 0, 8);
    }

    @SuppressWarnings("StreamResourceLeak") // whoever asks closes it
    private Stream<Row> rows() {
        try {
            return Files.lines(table).skip(1).map(text::row);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
