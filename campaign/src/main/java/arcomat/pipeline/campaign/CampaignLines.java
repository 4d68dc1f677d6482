package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignParser;
import arcomat.campaign.Variation;
import arcomat.pipeline.beside.BesideText;
import arcomat.pipeline.beside.TextsAround;
import arcomat.pipeline.campaign.measure.Measuring;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.WorldParameter;
import arcomat.world.WorldParser;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * A campaign, while somebody writes it: beside what it says itself, whether its world is there and
 * has what the campaign speaks of.
 *
 * @param place of the file, absolute
 */
public record CampaignLines(SourceFile text, Path place, TextsAround around) implements BesideText {
    @Override
    public List<Diagnostic> findings() {
        CampaignParser.Reading reading = CampaignParser.parse(text);
        return reading.campaign().map(this::about).orElse(reading.findings());
    }

    private List<Diagnostic> about(Campaign campaign) {
        Optional<SourceFile> world = around.text(file(campaign));
        if (world.isEmpty()) {
            String message = "there is no world '" + campaign.world().file() + "'";
            return List.of(
                    Diagnostic.error(CampaignPrograms.NO_WORLD, campaign.world().place(), message));
        }
        List<Diagnostic> findings = new ArrayList<>();
        findings.addAll(
                CampaignPrograms.unknownParameters(campaign, world.get(), campaign.world().file()));
        findings.addAll(Measuring.of(campaign, world.get()).findings());
        return findings;
    }

    private Path file(Campaign campaign) {
        return Objects.requireNonNull(place.getParent())
                .resolve(campaign.world().file())
                .normalize();
    }

    @Override
    public List<Link> links() {
        return CampaignParser.parse(text).campaign().map(this::links).orElse(List.of());
    }

    private List<Link> links(Campaign campaign) {
        Path file = file(campaign);
        List<Link> links = new ArrayList<>();
        links.add(new Link(campaign.world().place(), file, Optional.empty()));
        List<WorldParameter> parameters =
                around.text(file).map(WorldParser::parameters).orElse(List.of());
        for (Variation each : campaign.variations()) {
            parameters.stream()
                    .filter(parameter -> parameter.name().equals(each.parameter()))
                    .map(parameter -> new Link(each.place(), file, Optional.of(parameter.place())))
                    .forEach(links::add);
        }
        return links;
    }

    @Override
    public List<Choice> choices(int offset) {
        return new CampaignChoices(text, place, around).at(offset);
    }
}
