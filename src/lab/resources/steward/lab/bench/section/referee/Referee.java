package com.codingame.game;

import com.codingame.gameengine.core.AbstractPlayer.TimeoutException;
import com.codingame.gameengine.core.AbstractReferee;
import com.codingame.gameengine.core.MultiplayerGameManager;
import com.google.inject.Inject;

/** A game of 100 turns whose players repeat a number: what it costs is what the SDK costs. */
public class Referee extends AbstractReferee {

    private static final int TURNS = 100;

    @Inject
    private MultiplayerGameManager<Player> gameManager;

    @Override
    public void init() {
        gameManager.setMaxTurns(TURNS);
        gameManager.setFirstTurnMaxTime(10_000);
        gameManager.setTurnMaxTime(100);
    }

    @Override
    public void gameTurn(int turn) {
        int number = gameManager.getRandom().nextInt(1000);
        for (Player player : gameManager.getActivePlayers()) {
            player.sendInputLine(Integer.toString(number));
            player.execute();
        }
        for (Player player : gameManager.getActivePlayers()) {
            try {
                player.setScore(player.getScore() + Integer.parseInt(player.getOutputs().get(0)) - number + 1);
            } catch (TimeoutException late) {
                player.deactivate("late");
            }
        }
        gameManager.addToGameSummary("turn " + turn);
    }
}
