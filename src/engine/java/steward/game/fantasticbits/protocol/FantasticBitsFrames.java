package steward.game.fantasticbits.protocol;

import java.util.List;
import steward.game.BotFrames;
import steward.game.fantasticbits.Captures;
import steward.game.fantasticbits.EntityKind;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.game.fantasticbits.Spell;
import steward.game.fantasticbits.Variant;
import steward.game.fantasticbits.WizardCommand;
import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/** JSON frames that bots of Fantastic Bits are sent; answers are read by {@link FantasticBitsAnswer}. */
final class FantasticBitsFrames implements BotFrames {

    private static final SerializedString ENTITIES = new SerializedString("entities");

    /** The kinds that move; the last one is not in all leagues. */
    private static final List<EntityKind> KINDS = List.of(EntityKind.WIZARD, EntityKind.SNAFFLE, EntityKind.BLUDGER);

    private final FantasticBits game;
    private final FantasticBitsAnswer answer;
    private final String[] messages;

    FantasticBitsFrames(FantasticBits game) {
        this.game = game;
        answer = new FantasticBitsAnswer(game);
        messages = new String[game.players()];
    }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        Variant variant = game.settings().variant();
        out.writeStringProperty("variant", variant.text());
        JsonNumbers.write(out, "width", Pitch.WIDTH);
        JsonNumbers.write(out, "height", Pitch.HEIGHT);
        out.writeObjectPropertyStart("goal");
        JsonNumbers.write(out, "x", player == 0 ? Pitch.WIDTH : 0);
        JsonNumbers.write(out, "top", Pitch.MOUTH_TOP);
        JsonNumbers.write(out, "bottom", Pitch.MOUTH_BOTTOM);
        out.writeEndObject();
        JsonObject.writeEach(out, "posts", Pitch.POSTS, post -> DrawingJson.place(out, post.x(), post.y()));
        JsonObject.writeAll(out, "kinds", game.settings().bludgers() ? KINDS : KINDS.subList(0, 2), kind -> {
            out.writeStringProperty("kind", kind.text());
            JsonNumbers.write(out, "radius", kind.radius());
            JsonNumbers.write(out, "mass", kind.mass());
            JsonNumbers.write(out, "friction", kind.friction());
        });
        JsonNumbers.write(out, "postRadius", EntityKind.POST.radius());
        JsonNumbers.write(out, "captureReach", Captures.REACH);
        out.writeNumberProperty("maximumPower", WizardCommand.MOST_THRUST);
        out.writeNumberProperty("maximumThrow", WizardCommand.MOST_THROW);
        out.writeNumberProperty("maximumMagic", FantasticBits.MOST_MAGIC);
        JsonObject.writeAll(out, "spells", game.settings().spells() ? Spell.count() : 0, k -> {
            Spell spell = Spell.of(k);
            out.writeStringProperty("spell", spell.text());
            out.writeNumberProperty("cost", variant.cost(spell));
            out.writeNumberProperty("turns", variant.turns(spell));
        });
        out.writeNumberProperty("winningScore", game.winningScore());
        out.writeNumberProperty("maximumTurns", game.settings().maximumTurns());
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        FantasticBitsState.writePlayers(out, game);
        EntityJson.write(out, ENTITIES, game, false);
    }

    @Override
    public String readAnswer(int player, byte[] line, int length) {
        messages[player] = null;
        String wrong = answer.of(player).read(line, length);
        if (wrong == null) {
            messages[player] = answer.message();
            for (int wizard = 0; wizard < Pitch.WIZARDS_PER_PLAYER; wizard++) {
                game.command(player, wizard, answer.command(wizard));
            }
        }
        return wrong;
    }

    @Override
    public String message(int player) {
        return messages[player];
    }
}
