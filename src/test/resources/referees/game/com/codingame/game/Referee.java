package com.codingame.game;

import com.codingame.gameengine.core.AbstractPlayer.TimeoutException;
import com.codingame.gameengine.core.AbstractReferee;
import com.codingame.gameengine.core.MultiplayerGameManager;
import com.google.inject.Inject;

/** A small game on the SDK: guess a number; two to three players, leagues, a static that remembers, faults by seed. */
public class Referee extends AbstractReferee {

    private static int remembered;

    @Inject
    private MultiplayerGameManager<Player> gameManager;

    @Override
    public void init() {
        gameManager.setMaxTurns(5);
        gameManager.setTurnMaxTime(50);
        remembered++;
        System.out.println("noise of the referee");
    }

    @Override
    public void gameTurn(int turn) {
        if (turn == 2 && gameManager.getSeed() == 101) {
            System.exit(7);
        }
        if (turn == 2 && gameManager.getSeed() == 102) {
            throw new IllegalStateException("no such cell");
        }
        while (turn == 2 && gameManager.getSeed() == 103) {
            Thread.onSpinWait();
        }
        int number = gameManager.getRandom().nextInt(Integer.getInteger("league.level") * 100);
        for (Player player : gameManager.getActivePlayers()) {
            player.sendInputLine(turn + " " + number);
            player.execute();
        }
        for (Player player : gameManager.getActivePlayers()) {
            try {
                player.setScore(player.getScore() + (player.getOutputs().get(0).equals("" + number) ? 1 : 0));
            } catch (TimeoutException late) {
                player.deactivate("late");
                player.setScore(-1);
            }
        }
        gameManager.addToGameSummary("turn " + turn + ", remembered " + remembered);
    }
}
